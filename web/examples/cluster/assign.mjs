// A job of submit.mjs: the nearest circles of some points.
import path from "node:path";
import { formats } from "./formats/index.mjs";

/** The sections of the job's part. */
export async function assign({ input, format, distances, snapshot, ...range }, context) {
  const { read, encode } = formats[format];
  const xy = await read(path.resolve(context.folder, input), range);
  return context.diagram.use(snapshot, (diagram) => {
    const start = performance.now();
    const found = distances ? diagram.nearestMany(xy) : { ids: diagram.findMany(xy) };
    context.seconds += (performance.now() - start) / 1000;
    context.items += found.ids.length;
    return encode(found.ids, found.distances);
  });
}
