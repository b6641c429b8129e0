// First slot of each cell. One work group: each thread sums a run of cells, the first adds up the runs, each writes its own.
var<workgroup> run_begin: array<u32, WORKGROUP>;
fn pass_body(thread: u32) {
  let per_run = (p.cells.w + WORKGROUP - 1u) / WORKGROUP;
  let first = thread * per_run;
  let end = min(first + per_run, p.cells.w);
  var sum = 0u;
  for (var c = first; c < end; c += 1u) { sum += head.counter[c]; }
  run_begin[thread] = sum;
  workgroupBarrier();
  if thread == 0u {
    var slot = 0u;
    for (var run = 0u; run < WORKGROUP; run += 1u) {
      let count = run_begin[run];
      run_begin[run] = slot;
      slot += count;
    }
  }
  workgroupBarrier();
  if head.status.failed != 0u { return; }
  var slot = run_begin[thread];
  for (var c = first; c < end; c += 1u) {
    cell_start[c] = slot;
    slot += head.counter[c];
  }
}
