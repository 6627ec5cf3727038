// After each step: the contacts upon the disc get a direction and a speed, as in a whirlpool; those above its hole
// are left out, so that nothing holds a crate there.
import { startOver } from './start-over.js';

interface Contact {
  readonly position: readonly number[];
  readonly geometry1: Element | null;
  readonly geometry2: Element | null;
}

interface Collection extends HTMLElement {
  set_contacts: object[];
}

/** Metres. */
const HOLE = 0.8;

/** How much a crate is drawn inwards for each metre round. */
const INWARDS = 0.35;

export function whirl(event: Event): void {
  const collection = event.currentTarget as Collection;
  const scene = collection.closest('scene')!;
  const sensor = scene.querySelector<Element & { contacts: Contact[] }>('x3d-collision-sensor')!;
  const disc = scene.querySelector('[def="disc"]');
  const isUponDisc = ({ geometry1, geometry2 }: Contact) =>
    geometry1 === disc || geometry2 === disc;
  const isAboveHole = ({ position: [x, , z] }: Contact) => Math.hypot(x!, z!) < HOLE;

  const turned = (contact: Contact) => {
    const [x, , z] = contact.position as [number, number, number];
    return {
      ...contact,
      appliedParameters: ['USER_FRICTION', 'SPEED-1', 'FRICTION_COEFFICIENT-2'],
      frictionDirection: [z - INWARDS * x, 0, -x - INWARDS * z],
      frictionCoefficients: [0.8, 0.8],
      surfaceSpeed: [Number(collection.dataset.speed), 0],
    };
  };

  collection.set_contacts = sensor.contacts
    .filter((contact) => !(isUponDisc(contact) && isAboveHole(contact)))
    .map((contact) => (isUponDisc(contact) ? turned(contact) : contact));
  startOver(event);
}
