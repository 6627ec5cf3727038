// The chunk `water-elements`: water in pages.
import { waterCode, waterTypes } from '../physics-core/water.js';
import { learnTypes } from './bridge/index.js';
import { placeWater } from './bridge/water/place-water.js';
import { defineElements } from './define.js';
import { X3DWaterVolumeElement } from './x3d-water-volume.js';

/** With what moves in water. */
export async function whole(): Promise<{ provide(): void }> {
  await waterCode.load();
  return { provide };
}

function provide(): void {
  placeWater();
  learnTypes(waterTypes);
  defineElements([X3DWaterVolumeElement]);
}
