const tenths = new Intl.NumberFormat('en', { maximumFractionDigits: 1 });
const integer = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

export const whole = (value: number): string => integer.format(value);

/** Of a column whose head says so. */
export const milliseconds = (value: number): string => value.toFixed(2);

export const upToTenths = (value: number): string => tenths.format(value);

/** Of 1000 bytes, as in docs/chunks.md. */
export const kilobytes = (bytes: number): string => (bytes / 1000).toFixed(1);

/** Of a share from 0 to 1. */
export const percent = (share: number): string => `${Math.round(100 * share)} %`;
