// Curves over time, from keys.

/** The polynomial of degree five with the given value, slope and second derivative at both ends. */
export function quintic(t0, [p0, v0, a0], t1, [p1, v1, a1]) {
  const h = t1 - t0;
  const d = p1 - p0 - v0 * h - (a0 * h * h) / 2;
  const dv = (v1 - v0 - a0 * h) * h;
  const da = (a1 - a0) * h * h;
  const c3 = 10 * d - 4 * dv + da / 2;
  const c4 = -15 * d + 7 * dv - da;
  const c5 = 6 * d - 3 * dv + da / 2;
  return (t) => {
    const s = (t - t0) / h;
    return p0 + v0 * (t - t0) + (a0 * (t - t0) ** 2) / 2 + s ** 3 * (c3 + s * (c4 + s * c5));
  };
}

/**
 * A periodic C2 cubic spline through keys [time, value] in [0, period): the natural motion between key poses. Solves the cyclic
 * tridiagonal system for the second derivatives by plain elimination; there are never many keys.
 */
export function loopSpline(period, keys) {
  const n = keys.length;
  if (n === 1) return () => keys[0][1];
  const t = [...keys.map((k) => k[0]), keys[0][0] + period];
  const p = [...keys.map((k) => k[1]), keys[0][1]];
  const h = keys.map((_, i) => t[i + 1] - t[i]);
  const rows = keys.map((_, i) => {
    const before = (i + n - 1) % n;
    const row = new Array(n + 1).fill(0);
    row[before] += h[before];
    row[i] += 2 * (h[before] + h[i]);
    row[(i + 1) % n] += h[i];
    row[n] = 6 * ((p[i + 1] - p[i]) / h[i] - (p[i] - p[before]) / h[before]);
    return row;
  });
  const m = solve(rows);
  return (time) => {
    const s = t[0] + ((((time - t[0]) % period) + period) % period);
    let i = n - 1;
    while (i > 0 && t[i] > s) i--;
    const [a, b] = [(t[i + 1] - s) / h[i], (s - t[i]) / h[i]];
    return a * p[i] + b * p[i + 1] + (((a ** 3 - a) * m[i] + (b ** 3 - b) * m[(i + 1) % n]) * h[i] * h[i]) / 6;
  };
}

function solve(rows) {
  const n = rows.length;
  for (let k = 0; k < n; k++) {
    let pivot = k;
    for (let i = k + 1; i < n; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[pivot][k])) pivot = i;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    for (let i = 0; i < n; i++) {
      if (i === k || rows[i][k] === 0) continue;
      const f = rows[i][k] / rows[k][k];
      for (let j = k; j <= n; j++) rows[i][j] -= f * rows[k][j];
    }
  }
  return rows.map((row, k) => row[n] / row[k]);
}

/** Keys with slope zero at each, joined by quintics: holds stay exactly still. Periodic. */
export function easeKeys(period, keys) {
  const closed = [...keys, [keys[0][0] + period, keys[0][1]]];
  return (time) => {
    const s = keys[0][0] + ((((time - keys[0][0]) % period) + period) % period);
    let i = keys.length - 1;
    while (i > 0 && closed[i][0] > s) i--;
    const u = (s - closed[i][0]) / (closed[i + 1][0] - closed[i][0]);
    return closed[i][1] + (closed[i + 1][1] - closed[i][1]) * u * u * u * (10 + u * (6 * u - 15));
  };
}

/**
 * Follow-through: a damped spring that is pulled along by a periodic signal, run until it is periodic too. `frequency` in hertz,
 * `damping` 1 just does not overshoot. Samples are one period.
 */
export function follow(samples, fps, frequency, damping) {
  const w = 2 * Math.PI * frequency;
  const sub = 8;
  const dt = 1 / (fps * sub);
  let [x, v] = [samples[0], 0];
  let out = samples;
  for (let lap = 0; lap < 6; lap++)
    out = samples.map((target, i) => {
      const next = samples[(i + 1) % samples.length];
      const here = x;
      for (let k = 0; k < sub; k++) {
        v += (w * w * (target + ((next - target) * k) / sub - x) - 2 * damping * w * v) * dt;
        x += v * dt;
      }
      return here;
    });
  return out;
}
