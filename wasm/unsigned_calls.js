// How Emscripten's JavaScript calls a function of the module by its number. With 4 GB of memory
// there are addresses beyond 2^31, which come out negative; Emscripten's own version of this
// calls through two closures with lists of arguments, which is most of the cost of a small call
// (docs/DECISIONS.md, "Embind").
addToLibrary({
  $getDynCaller__deps: ["$wasmTable"],
  $getDynCaller: (signature, number) => {
    const plain = wasmTable.get(number);
    if (signature[0] !== "p") return plain;
    // As many parameters as any has.
    return (a, b, c, d, e, f, g, h, i, j, k) => plain(a, b, c, d, e, f, g, h, i, j, k) >>> 0;
  },
});
