const integer = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

export const whole = (value: number): string => integer.format(value);

/** Of a column whose head says so. */
export const milliseconds = (value: number): string => value.toFixed(2);
