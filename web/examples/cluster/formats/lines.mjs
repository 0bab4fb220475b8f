// Text files in which a record is a line: ranges of whole lines, one for each job.
import { withFile } from "../files.mjs";

const kLongestLine = 1 << 16;

/** The rest of the line at a place in a file, with its end. */
async function lineAt(file, input, place) {
  const rest = (await input.size()) - place;
  const bytes = await input.readAll(Math.min(rest, kLongestLine), place);
  const end = bytes.indexOf("\n");
  if (end < 0 && rest > kLongestLine)
    throw new Error(`${file}: the line at byte ${place} is very long`);
  return end < 0 ? bytes : bytes.subarray(0, end + 1);
}

/** The first line of a file, with its end. */
export function firstLine(file) {
  return withFile(file, "r", (input) => lineAt(file, input, 0));
}

/** Ranges {from, to, size} of whole lines, of about this many bytes; `size` is in MB. */
export function splitLines(file, { start = 0, bytes }) {
  return withFile(file, "r", async (input) => {
    const size = await input.size();
    const ranges = [];
    for (let from = start; from < size; ) {
      const guess = from + bytes;
      const to = guess >= size ? size : guess + (await lineAt(file, input, guess)).length;
      ranges.push({ from, to: Math.min(to, size), size: (to - from) / 1e6 });
      from = to;
    }
    return ranges;
  });
}

/** The text of a range. */
export async function textOf(file, { from, to }) {
  const bytes = await withFile(file, "r", (input) => input.readAll(to - from, from));
  return bytes.toString("utf8");
}
