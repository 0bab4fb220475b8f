// Files that are read and written in pieces. The system may read or write fewer bytes than it was
// asked for; here all of them are, or an error says which file it was.
import { randomUUID } from "node:crypto";
import { open, rename, rm } from "node:fs/promises";

const kAtOnce = 1 << 30; // bytes; systems take no more than 2 GB in a call

class OpenFile {
  #handle;
  #name;

  constructor(handle, name) {
    this.#handle = handle;
    this.#name = name;
  }

  /** Gives the error of a call a name, as the system names files only when it opens them. */
  async #named(call) {
    try {
      return await call;
    } catch (error) {
      error.path ??= this.#name;
      throw error;
    }
  }

  async size() {
    return (await this.#named(this.#handle.stat())).size;
  }

  /** As many bytes as there are, in a buffer of their own, from a place in the file on. */
  async readAll(length, position) {
    const bytes = Buffer.from(new ArrayBuffer(length));
    for (let at = 0; at < length; ) {
      const some = Math.min(length - at, kAtOnce);
      const { bytesRead } = await this.#named(this.#handle.read(bytes, at, some, position + at));
      if (bytesRead === 0) throw new Error(`${this.#name} has become shorter`);
      at += bytesRead;
    }
    return bytes;
  }

  /** Writes bytes to a place in the file; without one, after what was written last. */
  async writeAll(bytes, position) {
    for (let at = 0; at < bytes.length; ) {
      const some = Math.min(bytes.length - at, kAtOnce);
      const place = position === undefined ? null : position + at;
      const { bytesWritten } = await this.#named(this.#handle.write(bytes, at, some, place));
      if (bytesWritten === 0) throw new Error(`${this.#name}: nothing could be written`);
      at += bytesWritten;
    }
  }

  /** Has the system put what was written on the disk, and say whether that has room for it. */
  sync() {
    return this.#named(this.#handle.sync());
  }

  close() {
    return this.#named(this.#handle.close());
  }
}

/** Opens a file for an action, and returns what that returns. `flags` are those of `open`. */
export async function withFile(name, flags, action) {
  const file = new OpenFile(await open(name, flags), name);
  try {
    return await action(file);
  } finally {
    await file.close();
  }
}

/** All bytes of a file. */
export function readWhole(name) {
  return withFile(name, "r", async (file) => file.readAll(await file.size(), 0));
}

/**
 * Has an action write a file under another name, and moves it into place: it is whole or not there,
 * and nothing stays of one that could not be written.
 */
export async function replaceFile(name, action) {
  const draft = `${name}.${randomUUID()}`;
  try {
    await withFile(draft, "w", action);
    await rename(draft, name);
  } catch (error) {
    await rm(draft, { force: true });
    if (error.path === draft) error.path = name;
    throw error;
  }
}
