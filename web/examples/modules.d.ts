// Modules that the examples import and TypeScript finds no declarations of.
declare module "d3-contour";
declare module "d3-delaunay";
declare module "d3-force";
declare module "d3-geo";
declare module "d3-selection";
declare module "leaflet";
declare module "plotly.js-gl2d-dist-min";
