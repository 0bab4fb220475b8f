// Text files in which a record is a line: ranges of whole lines, one for each job.
import { open, stat } from "node:fs/promises";

const kLongestLine = 1 << 16;

/** The rest of the line at a place in a file, with its end. */
async function lineAt(file, input, place) {
  const { buffer, bytesRead } = await input.read(
    Buffer.alloc(kLongestLine),
    0,
    kLongestLine,
    place,
  );
  const end = buffer.subarray(0, bytesRead).indexOf("\n");
  if (end < 0 && bytesRead === kLongestLine)
    throw new Error(`${file}: the line at byte ${place} is very long`);
  return buffer.subarray(0, end < 0 ? bytesRead : end + 1);
}

/** The first line of a file, with its end. */
export async function firstLine(file) {
  const input = await open(file);
  try {
    return await lineAt(file, input, 0);
  } finally {
    await input.close();
  }
}

/** Ranges {from, to, size} of whole lines, of about this many bytes; `size` is in MB. */
export async function splitLines(file, { start = 0, bytes }) {
  const { size } = await stat(file);
  const input = await open(file);
  try {
    const ranges = [];
    for (let from = start; from < size; ) {
      const guess = from + bytes;
      const to = guess >= size ? size : guess + (await lineAt(file, input, guess)).length;
      ranges.push({ from, to: Math.min(to, size), size: (to - from) / 1e6 });
      from = to;
    }
    return ranges;
  } finally {
    await input.close();
  }
}

/** The text of a range. */
export async function textOf(file, { from, to }) {
  const bytes = Buffer.alloc(to - from);
  const input = await open(file);
  try {
    const { bytesRead } = await input.read(bytes, 0, bytes.length, from);
    if (bytesRead !== bytes.length) throw new Error(`${file} has become shorter`);
  } finally {
    await input.close();
  }
  return bytes.toString("utf8");
}
