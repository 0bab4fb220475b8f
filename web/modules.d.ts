// What the page imports and TypeScript finds no declarations of.
declare module "d3-delaunay";
declare module "d3-force";
declare module "d3-selection";
declare module "d3-dsv";
declare module "leaflet";
