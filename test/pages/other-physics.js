/* global CreateInteractiveObjects:writable, XMLHttpRequest, defineClass, document, requestAnimFrame, window, x3dom */
// x3dom with a stand-in for the physics of its own (x3dom-physics.js, and x3dom-full.js up to 1.7), which no package registry
// has: it hangs on the page by the same names. Each of its frames is counted, and lifts the Transforms of all scenes.
var request = new XMLHttpRequest();
request.open('GET', '/node_modules/x3dom/x3dom.js', false);
request.send();
// In one script, as in a full build.
(0, eval)(request.responseText);

(function () {
  var ran = (window.ownEngine = { begun: 0, frames: 0 });
  var names =
    'RigidBodyCollection RigidBody CollidableShape CollisionCollection CollisionSensor BallJoint MotorJoint SliderJoint UniversalJoint SingleAxisHingeJoint DoubleAxisHingeJoint';
  names.split(' ').forEach(function (name) {
    var type = defineClass(
      x3dom.nodeTypes.X3DChildNode,
      function (context) {
        type.superClass.call(this, context);
        this.addField_SFFloat(context, 'mass', 1);
        this.addField_SFVec3f(context, 'position', 0, 0, 0);
      },
      {},
    );
    x3dom.registerNodeType(name, 'RigidBodyPhysics', type);
  });

  function main() {
    ran.frames++;
    window.requestAnimFrame(main);
    if (document.readyState === 'complete') lift();
  }

  function lift() {
    document.querySelectorAll('x3d > scene > transform').forEach(function (transform) {
      transform.setAttribute('translation', '0 100 0');
    });
  }

  CreateInteractiveObjects = function () {};

  window.onload = function () {
    ran.begun++;
    requestAnimFrame(main);
    CreateInteractiveObjects();
  };
})();
