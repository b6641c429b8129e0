// Finds the first slot of each cell. Each work group handles a block of cells. All its threads together add up the
// particles of the blocks before it. Then each thread counts the particles in a run of cells, the first thread adds up
// the runs, and each thread writes the first slots of its run.
var<workgroup> blocks_before: array<u32, WORKGROUP>;
var<workgroup> run_begin: array<u32, WORKGROUP>;
fn pass_body(thread: u32) {
  let block = thread / WORKGROUP;
  let own = thread % WORKGROUP;
  var before = 0u;
  for (var b = own; b < block; b += WORKGROUP) { before += head.counter[p.cells.w + b]; }
  blocks_before[own] = before;
  let per_run = CELL_BLOCK / WORKGROUP;
  let first = block * CELL_BLOCK + own * per_run;
  let end = min(first + per_run, p.cells.w);
  var sum = 0u;
  for (var c = first; c < end; c += 1u) { sum += head.counter[c]; }
  run_begin[own] = sum;
  workgroupBarrier();
  if own == 0u {
    var slot = 0u;
    for (var i = 0u; i < WORKGROUP; i += 1u) { slot += blocks_before[i]; }
    for (var run = 0u; run < WORKGROUP; run += 1u) {
      let count = run_begin[run];
      run_begin[run] = slot;
      slot += count;
    }
  }
  workgroupBarrier();
  if head.status.failed != 0u { return; }
  var slot = run_begin[own];
  for (var c = first; c < end; c += 1u) {
    cell_start[c] = slot;
    slot += head.counter[c];
  }
}
