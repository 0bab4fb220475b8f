// Sections of parts, one after the other, into a file a section.
import { open } from "node:fs/promises";

/** Writes `out`.NAME for each section of that name; `first` is what a new file begins with. */
export async function joinSections(out, parts, { first } = {}) {
  const files = new Map();
  try {
    for await (const sections of parts()) {
      for (const [name, bytes] of Object.entries(sections)) {
        const path = `${out}.${name}`;
        if (!files.has(path)) {
          files.set(path, await open(path, "w"));
          if (first) await files.get(path).writeFile(first);
        }
        await files.get(path).writeFile(bytes);
      }
    }
  } finally {
    for (const file of files.values()) await file.close();
  }
  return [...files.keys()];
}
