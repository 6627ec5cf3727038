/** A line of flat x, y, z as so many segments of one length along it; 0: as it is. */
export function alongSegments(line: readonly number[], segments: number): number[] {
  const points = Math.floor(line.length / 3);
  if (segments === 0 || points < 2) return line.slice(0, 3 * points);
  const reached = [0];
  for (let i = 1; i < points; i++) {
    const [x, y, z] = [0, 1, 2].map((k) => line[3 * i + k]! - line[3 * i - 3 + k]!);
    reached.push(reached[i - 1]! + Math.sqrt(x! * x! + y! * y! + z! * z!));
  }
  const whole = reached[points - 1]!;
  const out: number[] = [];
  for (let n = 0, i = 0; n <= segments; n++) {
    const at = (whole * n) / segments;
    while (i < points - 2 && reached[i + 1]! < at) i++;
    const share = (at - reached[i]!) / (reached[i + 1]! - reached[i]! || 1);
    for (let k = 0; k < 3; k++)
      out.push(line[3 * i + k]! + share * (line[3 * i + 3 + k]! - line[3 * i + k]!));
  }
  return out;
}
