// After each step: what the motor measures.

interface Motor extends Element {
  readonly motor1Angle: number;
  readonly motor1AngleRate: number;
}

export function showMotor({ currentTarget }: Event): void {
  const main = (currentTarget as Element).closest('main')!;
  const { motor1Angle, motor1AngleRate } = main.querySelector<Motor>('x3d-motor-joint')!;
  main.querySelector('output')!.textContent =
    `motor1Angle ${motor1Angle.toFixed(2)} rad, motor1AngleRate ${motor1AngleRate.toFixed(2)} rad/s`;
}
