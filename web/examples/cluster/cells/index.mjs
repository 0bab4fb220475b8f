// The formats of files of cells, by the options of build.mjs. Each has `encode`, the bytes of one
// cell {id, area, polygons}, where a polygon is rings of flat x, y, …, the first one around the
// others; and `join`, which makes a file of these bytes in the sections of parts.
import * as flatgeobuf from "./flatgeobuf.mjs";
import * as geojson from "./geojson.mjs";
import * as geoparquet from "./geoparquet.mjs";

export const cellFormats = { geojson, flatgeobuf, geoparquet };
