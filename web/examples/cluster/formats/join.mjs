// Sections of parts, one after the other, into a file a section.
import { withFile } from "../files.mjs";

/** Writes `out`.NAME for each section of that name; `first` is what a new file begins with. */
export async function joinSections(out, parts, { first = "" } = {}) {
  const files = new Set();
  for await (const sections of parts()) {
    for (const [name, bytes] of Object.entries(sections)) {
      const file = `${out}.${name}`;
      const isNew = !files.has(file);
      files.add(file);
      await withFile(file, isNew ? "w" : "a", async (output) => {
        if (isNew) await output.writeAll(Buffer.from(first));
        await output.writeAll(bytes);
      });
    }
  }
  return [...files];
}
