// Runs one program in the sandbox of frame.html, and tells the page what it prints, what goes wrong
// and how high its picture is. The build puts it into frame.html.
{
  const tell = (told) => parent.postMessage(told, "*"); // the sandbox has no origin to name
  const addressOf = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));

  const textOf = (value) => {
    if (typeof value === "string") return value;
    if (ArrayBuffer.isView(value)) return textOf(Array.from(value));
    if (value instanceof Map) return `Map ${JSON.stringify([...value])}`;
    return JSON.stringify(value, null, 1)?.replace(/\s+/g, " ") ?? String(value);
  };
  for (const kind of ["log", "info", "warn", "error"])
    console[kind] = (...values) => tell({ kind: "print", text: values.map(textOf).join(" ") });

  let address = ""; // of the program
  Error.stackTraceLimit = 50; // Chromium's ten calls can all be the library's
  /** The line of the program that was being run, if an error's stack tells. */
  const lineOf = (error) => {
    const stack = String(error?.stack ?? "");
    const at = address === "" ? -1 : stack.indexOf(`${address}:`);
    return at < 0 ? undefined : Number.parseInt(stack.slice(at + address.length + 1), 10);
  };
  const fail = (message, line) => tell({ kind: "failed", message, line });
  addEventListener("error", ({ error, message, filename, lineno }) => {
    const own = filename === address ? lineno : undefined; // of a syntax error, say
    fail(String(error ?? message), error?.turnedAt ?? lineOf(error) ?? own);
  });
  addEventListener("unhandledrejection", ({ reason }) =>
    fail(String(reason), reason?.turnedAt ?? lineOf(reason)),
  );

  /** Seconds that a program may compute without a pause, in which this page can answer. */
  const kLongest = 5;
  let since = 0;
  globalThis.$turn = (turnedAt) => {
    const now = performance.now();
    if (since === 0) {
      since = now;
      setTimeout(() => {
        since = 0;
      });
    } else if (now - since > 1000 * kLongest) {
      const message = `the program was stopped: it computed for ${kLongest} s without a pause`;
      throw Object.assign(new Error(message), { turnedAt });
    }
  };

  const script = (properties) =>
    document.head.appendChild(Object.assign(document.createElement("script"), properties));

  addEventListener("message", ({ source, data }) => {
    if (source !== parent) return;
    const { modules, style, program } = data;
    document.head.appendChild(document.createElement("style")).textContent = style;
    const imports = Object.fromEntries(
      Object.entries(modules).map(([name, text]) => [name, addressOf(text)]),
    );
    script({ type: "importmap", textContent: JSON.stringify({ imports }) });
    new ResizeObserver(() => {
      tell({ kind: "height", height: document.body.offsetHeight });
    }).observe(document.body);
    address = addressOf(program);
    script({ type: "module", src: address, onload: () => tell({ kind: "done" }) });
  });
  addEventListener("load", () => tell({ kind: "ready" }));
}
