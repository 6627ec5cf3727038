import { bodies, colored } from './pictures.js';

export const heap = bodies(60, (i) => `${colored(i)}<box size="1.2 1.2 1.2"></box>`);

interface Area {
  _pickingInfo: {
    pickObj: { _xmlNode: Element | null } | null;
    pickPos: { toString(): string } | null;
    pickNorm: { toString(): string } | null;
  };
}

/** The element that x3dom finds under a point of the picture, where on it and with which normal. */
export function found(x3d: Element, x: number, y: number): string[] {
  const { doc } = (
    x3d as unknown as {
      runtime: {
        canvas: {
          doc: {
            ctx: { pickValue(area: Area, x: number, y: number, button: number): boolean };
            _viewarea: Area;
          };
        };
      };
    }
  ).runtime.canvas;
  if (!doc.ctx.pickValue(doc._viewarea, x, y, 1)) return [''];
  const { pickObj, pickPos, pickNorm } = doc._viewarea._pickingInfo;
  const id = pickObj?._xmlNode?.id;
  // Where there is nothing the last answer is left.
  return id ? [id, String(pickPos), String(pickNorm)] : [''];
}
