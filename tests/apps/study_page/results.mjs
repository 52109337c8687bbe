// A study as results.json holds it, with variants of every status, for the tests of the page.

/** The smaller of two decides: errors that fall with dt, times that grow. */
function variant(dt, filter, solver, factor) {
  const error = 0.02 * dt ** 1.1 * factor, seconds = (0.9 / dt) * (filter === 'clamp' ? 0.061 : 0.05) / factor ** 0.5;
  const name = `dt=${dt}, filter=${filter}, solver=${solver}`;
  const errors = { mean_distance: error, max_distance: 6 * error, energy: 1e-7 * dt * factor, penetration: 0 };
  return {
    name, values: { dt: String(dt), filter, solver }, status: 'finished', reason: '',
    seconds, seconds_low: 0.97 * seconds, seconds_high: 1.06 * seconds, steps: Math.round(2 / dt),
    newton_iterations: 3 - factor / 10, linear_iterations: 12 * factor, steps_not_converged: 0, errors,
    at: Array.from({ length: 20 }, (_, i) => {
      const time = 0.1 * (i + 1), share = Math.abs(Math.sin(2.1 * time)) + 0.1;
      return { time, mean_distance: share * error, max_distance: 6 * share * error,
               energy: share * errors.energy, penetration: 0 };
    }),
    peak_memory_bytes: 41e6 + 1e6 * factor, run: `runs/${name.replaceAll(' ', '')}`,
  };
}

/** As the study command finds them: what no other beats in both, fastest first. */
function front(variants, error) {
  const whole = variants.filter((v) => ['finished', 'not_converged'].includes(v.status));
  const beats = (a, b) => a.seconds <= b.seconds && a.errors[error] <= b.errors[error] &&
                          (a.seconds < b.seconds || a.errors[error] < b.errors[error]);
  return whole.filter((v) => !whole.some((other) => beats(other, v)))
    .sort((a, b) => a.seconds - b.seconds).map((v) => v.name);
}

export const hostileName = `</script><img src=x onerror="window.harmed=1"> $& 'quoted' "twice" & ünicode`;

export function makeResults(changes = {}) {
  const steps = [0.0333, 0.0166, 0.00833, 0.00416, 0.00208];
  const solvers = ['pcg', 'strand_cholesky', 'jacobi'];
  const variants = steps.flatMap((dt) => ['tight', 'clamp'].flatMap((filter) =>
    solvers.map((solver, i) => variant(dt, filter, solver, 1 + 0.37 * i + (filter === 'clamp' ? 0.2 : 0)))));
  const lost = { seconds: null, seconds_low: null, seconds_high: null, peak_memory_bytes: null,
                 newton_iterations: null, linear_iterations: null, steps_not_converged: null, at: [],
                 errors: { mean_distance: null, max_distance: null, energy: null, penetration: null } };
  const some = (index, change) => Object.assign(variants[index], change);
  some(1, { status: 'not_converged', steps_not_converged: 7,
            reason: 'Newton\'s method met its cap of 3 iterations in 7 of 60 steps' });
  some(5, { status: 'exploded', errors: lost.errors, at: [],
            reason: 'a vertex went 12 strand lengths further than in the reference' });
  some(9, { ...lost, status: 'failed', reason: 'step 14: the energy "twist" is not finite at strand 3, vertex 17' });
  some(15, { ...lost, status: 'refused', reason: '/solver: expected one of "pcg", "auto"; did you mean "pcg"?' });
  some(21, { ...lost, status: 'interrupted', reason: 'interrupted by the user' });
  some(2, { name: hostileName });
  some(8, { errors: { ...variants[8].errors, energy: null } });
  const errors = [
    { name: 'mean_distance', label: 'mean distance of vertices', unit: 'm' },
    { name: 'max_distance', label: 'largest distance of a vertex', unit: 'm' },
    { name: 'energy', label: 'error of the energy', unit: 'J' },
    { name: 'penetration', label: 'penetration', unit: 'm' },
  ];
  const fronts = Object.fromEntries(errors.map(({ name }) => [name, front(variants, name)]));
  return {
    study: { name: 'dt_newton', about: 'How long a step may be, and how many Newton iterations it needs: a hanging curl that swings for two seconds.', scene: 'hanging_curl' },
    duration: 2, compare_every: 0.1, repetitions: 3,
    machine: { processor: 'Intel Xeon, 2 cores', threads: 2, version: '0.6.0', compiler: 'GNU 12.2.0', build_type: 'Release' },
    jobs: 1, timing_note: '', errors,
    axes: [{ name: 'dt', label: 'time step', unit: 's', values: steps.map(String) },
           { name: 'filter', label: 'filter', unit: '', values: ['tight', 'clamp'] },
           { name: 'solver', label: 'solver', unit: '', values: solvers }],
    default: variants[0].name,
    reference: { ...variant(1e-4, 'tight', 'pcg', 1), name: 'reference' },
    variants, fronts,
    recommendations: { mean_distance: [
      `for errors under 1 mm: ${variants[0].name}, the default (${variants[0].seconds.toFixed(2)} s, 0.5 mm)`,
      `for errors under 0.1 mm: ${variants[18].name}, 0.12 times as fast as the default`] },
    ...changes,
  };
}

/** The same without a reference: no errors, no fronts, no advice. */
export function withoutReference() {
  const { reference, ...rest } = makeResults({ errors: [], fronts: {}, recommendations: {} });
  rest.variants.forEach((v) => { v.errors = {}; v.at = []; });
  return rest;
}

/** A study of one axis with a number of variants, the last of which has a long name. */
export function ofManyVariants(count) {
  const steps = Array.from({ length: count }, (_, i) => +(0.05 / (1 + 0.05 * i)).toPrecision(5));
  const variants = steps.map((dt) => variant(dt, 'tight', 'pcg', 1 + 0.3 * Math.sin(97 * dt * 1e4)));
  variants.forEach((v, i) => Object.assign(v, { name: `dt=${steps[i]}`, values: { dt: String(steps[i]) } }));
  variants.at(-1).name = `a very long name ${'with many words '.repeat(20)}`;
  return makeResults({
    axes: [{ name: 'dt', label: 'time step', unit: 's', values: steps.map(String) }],
    default: variants[0].name, variants, repetitions: 1,
    timing_note: 'Four variants ran at once: their times are of variants that shared the machine.',
    fronts: { mean_distance: front(variants, 'mean_distance') },
  });
}
