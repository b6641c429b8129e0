//! Times each pass on a device by the device's own clock.
use crate::buffers::read;
use crate::device::Gpu;
use crate::error::GpuError;

/// Timestamp queries for the beginning and the end of each dispatch of a step.
pub(crate) struct PassClock {
    queries: wgpu::QuerySet,
    ticks: wgpu::Buffer,
    dispatches: usize,
}

impl PassClock {
    /// Creates the queries for a step with this number of dispatches.
    pub(crate) fn new(gpu: &Gpu, dispatches: usize) -> Result<PassClock, GpuError> {
        if !gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            return Err(GpuError::NoPassTimes { adapter: gpu.name() });
        }
        let (count, most) = (2 * dispatches, wgpu::QUERY_SET_MAX_QUERIES as usize);
        if count > most {
            return Err(GpuError::TooManyPasses { passes: dispatches, most: most / 2 });
        }
        let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("pass times"),
            ty: wgpu::QueryType::Timestamp,
            count: count as u32,
        });
        let ticks = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("pass times"),
            size: (count * size_of::<u64>()) as u64,
            usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        Ok(PassClock { queries, ticks, dispatches })
    }

    /// Returns the timestamp writes for the compute pass of the `i`-th dispatch.
    pub(crate) fn around(&self, i: usize) -> wgpu::ComputePassTimestampWrites<'_> {
        let first = 2 * i as u32;
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        }
    }

    /// Resolves the queries into a buffer. This is recorded after the last dispatch.
    pub(crate) fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..2 * self.dispatches as u32, &self.ticks, 0);
    }

    /// Returns the duration of each dispatch, ms.
    pub(crate) fn milliseconds(&self, gpu: &Gpu) -> Result<Vec<f64>, GpuError> {
        let ticks: Vec<[u64; 2]> = read(gpu, &self.ticks, self.dispatches)?;
        let nanoseconds = f64::from(gpu.queue.get_timestamp_period());
        Ok(ticks.iter().map(|[begin, end]| end.saturating_sub(*begin) as f64 * nanoseconds * 1e-6).collect())
    }
}
