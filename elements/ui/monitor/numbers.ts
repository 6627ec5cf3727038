const tenths = new Intl.NumberFormat('en', { maximumFractionDigits: 1 });
const ofTwo = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 });
const integer = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

export const whole = (value: number): string => integer.format(value);

/** Of a column whose head says so. */
export const milliseconds = (value: number): string => value.toFixed(2);

export const upToTenths = (value: number): string => tenths.format(value);

/** Of 1000 bytes, as in docs/chunks.md. */
export const kilobytes = (bytes: number): string => (bytes / 1000).toFixed(1);

/** Of metres. */
export function distance(metres: number): string {
  if (metres >= 1) return `${upToTenths(metres)} m`;
  if (metres >= 0.01) return `${whole(metres * 100)} cm`;
  // What single precision leaves is none.
  return metres >= 1e-5 ? `${ofTwo.format(metres * 1000)} mm` : '0';
}

/** Of a share from 0 to 1. */
export const percent = (share: number): string => `${Math.round(100 * share)} %`;
