/** What a mesh of a rope consists of; written anew in each frame in which it moved. */
export interface Form {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly texCoords: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  /** How far it reaches beside its points, in what x3dom draws. */
  readonly reach: number;
  /** Points of the rope: x, y, z of each, in what x3dom draws. */
  write(points: Float64Array): void;
}
