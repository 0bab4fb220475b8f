// Modules that the page imports and TypeScript finds no declarations of: as much as is used.
declare module "d3-dsv" {
  export function csvFormatRows(rows: readonly (readonly string[])[]): string;
  export function dsvFormat(separator: string): { parseRows(text: string): string[][] };
}

declare module "d3-geo" {
  type Place = [longitude: number, latitude: number];
  type Geometry = { type: string; coordinates: unknown };
  interface Projection {
    (place: Place): [x: number, y: number] | null;
    invert(point: [x: number, y: number]): Place;
    rotate(angles: Place): this;
    rotate(): [lambda: number, phi: number, gamma: number];
    translate(point: [x: number, y: number]): this;
    translate(): [x: number, y: number];
    scale(value: number): this;
    scale(): number;
    clipAngle(degrees: number): this;
    precision(pixels: number): this;
  }
  interface Path {
    (object: Geometry): string | null;
    digits(count: number): this;
  }
  interface Circle {
    (): Geometry;
    center(place: Place): this;
    radius(degrees: number): this;
    precision(degrees: number): this;
  }
  export function geoOrthographic(): Projection;
  export function geoPath(projection: Projection): Path;
  export function geoCircle(): Circle;
  export function geoDistance(a: readonly number[], b: readonly number[]): number;
  export const geoEqualEarthRaw: {
    (lambda: number, phi: number): [number, number];
    invert(x: number, y: number): [number, number];
  };
}
