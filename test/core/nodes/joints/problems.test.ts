import assert from 'node:assert/strict';
import { addBody, addJoint, box, close, codes, fact, height, way, world } from '../../helpers.js';
import { only } from '../problems.js';

fact('a joint that names nobody is told and holds once it names somebody', async () => {
  const w = await world();
  const joint = addJoint(w, 'BallJoint', {});
  w.step();
  only(w, 'no-body');
  assert.equal(w.stats.joints, 0);
  const ball = addBody(w);
  joint.set('body2', ball);
  w.advance(0.5);
  close(height(ball), 0, 1e-4, 'm');
  assert.deepEqual(codes(w), []);
});

fact('a joint that names one body twice is told, holds nothing and breaks nothing', async () => {
  const w = await world();
  const ball = addBody(w);
  const joint = addJoint(w, 'BallJoint', { body1: ball, body2: ball });
  w.advance(0.5);
  close(height(ball), -way(9.8, 0.5), 1e-3, 'm');
  only(w, 'same-body');
  joint.set('body2', null);
  w.step(0);
  assert.deepEqual(codes(w), [], 'cured');
});

fact('masses very unlike on one joint are told', async () => {
  const w = await world();
  const [light, heavy] = [addBody(w, { mass: 0.01 }), addBody(w, { mass: 50 })];
  addJoint(w, 'BallJoint', { body1: light, body2: heavy });
  w.step();
  close(only(w, 'mass-ratio').value as number, 5000, 1e-6);
});

fact('a hinge without a direction is told and takes Y', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { angularVelocity: [1, 2, 3] });
  const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: ball, axis: [0, 0, 0] });
  w.advance(0.2);
  assert.equal(only(w, 'bad-value').attribute, 'axis');
  close(ball.get('angularVelocity') as number[], [0, 2, 0], 2e-3, 'rad/s');
  hinge.set('axis', [0, 0, 1]);
  w.step();
  assert.deepEqual(codes(w), []);
});

/** A motor on a ball, and what is told of it. */
async function motor(fields: Record<string, unknown>) {
  const w = await world();
  const joint = w.add('MotorJoint', { body1: addBody(w), ...fields });
  w.step();
  return { w, joint };
}

fact('a motor with a torque about no direction is told, until it has one', async () => {
  const { w, joint } = await motor({ motor1Axis: [0, 0, 0], axis1Torque: 5 });
  const { attribute, message } = only(w, 'idle-motor');
  assert.equal(attribute, 'motor1Axis');
  assert.match(message, /motor1Axis="0 0 0" has no direction, so axis1Torque turns nothing/);
  joint.set('motor1Axis', [0, 1, 0]);
  w.step();
  assert.deepEqual(codes(w), []);
});

fact(
  'a torque about an axis that enabledAxes leaves out is told, where nobody wrote that',
  async () => {
    const { w, joint } = await motor({ axis3Torque: 5 });
    const { attribute, message } = only(w, 'idle-motor');
    assert.equal(attribute, 'enabledAxes');
    assert.match(
      message,
      /axis3Torque turns nothing, since enabledAxes is 1; write enabledAxes="3"/,
    );
    joint.set('enabledAxes', 2);
    w.step();
    assert.deepEqual(codes(w), [], 'switched off');
  },
);

fact('an angle of a motor without any torque is told to be no target', async () => {
  const { w, joint } = await motor({ axis1Angle: 1 });
  const { attribute, message } = only(w, 'idle-motor');
  assert.equal(attribute, 'axis1Torque');
  assert.match(message, /axis1Angle is no target and turns nothing; a motor turns by axis1Torque/);
  let again = 0;
  w.on('problem', () => again++);
  joint.set('axis1Angle', 1.5);
  w.step();
  assert.equal(again, 0, 'another angle is no other mistake');
  joint.set('axis1Torque', 0);
  w.step();
  assert.deepEqual(codes(w), [], 'who writes torques knows');
  joint.unset('axis1Torque');
  joint.set('axis1Angle', 0);
  w.step();
  assert.deepEqual(codes(w), [], 'none');
});

fact(
  'a motor with autoCalc whose first axis has no direction still turns about its third',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const post = addBody(w, { fixed: true, position: [3, 0, 0] });
    const crate = addBody(w, { geometry: [box(1)] });
    addJoint(w, 'MotorJoint', {
      body1: post,
      body2: crate,
      autoCalc: true,
      enabledAxes: 3,
      // As X3D 3 has it by default.
      motor1Axis: [0, 0, 0],
      motor3Axis: [0, 1, 0],
      axis2Torque: 1,
      axis3Torque: 1,
    });
    w.advance(0.5);
    // 1 N m on a cube of 1 kg and 1 m, whose inertia is 1/6 kg m²: 6 rad/s², the other way round for body2.
    close(crate.get('angularVelocity') as number[], [0, -3, 0], 1e-3, 'rad/s');
    // There is no second axis at right angles to both.
    assert.match(only(w, 'idle-motor').message, /autoCalc/);
  },
);
