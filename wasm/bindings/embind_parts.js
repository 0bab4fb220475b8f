// Parts of Embind's JavaScript in which ours differs from Emscripten's.
addToLibrary({
  // How a function of the module is called by its number. With 4 GB of memory there are addresses
  // beyond 2^31, which come out negative; Emscripten's own version calls through two closures with
  // lists of arguments, which is most of the cost of a small call (docs/DECISIONS.md, "Embind").
  $getDynCaller__deps: ["$wasmTable"],
  $getDynCaller: (signature, number) => {
    const plain = wasmTable.get(number);
    if (signature[0] !== "p") return plain;
    // As many parameters as any has.
    return (a, b, c, d, e, f, g, h, i, j, k, l) => plain(a, b, c, d, e, f, g, h, i, j, k, l) >>> 0;
  },
});

/** Not while Embind writes the types, with a library of its own. */
const isEmbind = "$readPointer" in LibraryManager.library;
addToLibrary({
  // parts.h
  areTypesWritten: isEmbind ? () => false : () => true,
  // arrays.h
  copied__deps: isEmbind ? ["$Emval"] : [],
  copied: (view) => {
    try {
      return Emval.toHandle(Emval.toValue(view).slice());
    } catch {
      return 0;
    }
  },
});
const unused = {
  // Strings of wide characters, which none of our calls takes or gives.
  _embind_register_std_wstring__deps: [],
  _embind_register_std_wstring: (_type, _size, _name) => {},
};
const records = {
  // How a record comes out of the module. Emscripten's own version goes over its fields by
  // `for in`, which also meets what a page has put on Object.prototype. None of ours go in.
  _embind_finalize_value_object__deps: [
    "$structRegistrations",
    "$readPointer",
    "$whenDependentTypesAreResolved",
    "$GenericWireTypeSize",
  ],
  _embind_finalize_value_object: (type) => {
    const { name, rawDestructor, fields } = structRegistrations[type];
    delete structRegistrations[type];
    const types = fields.map(({ getterReturnType }) => getterReturnType);
    whenDependentTypesAreResolved([type], types, (converters) => [
      {
        name,
        fromWireType: (pointer) => {
          const record = {};
          for (let k = 0; k < fields.length; ++k) {
            const { fieldName, getter, getterContext } = fields[k];
            record[fieldName] = converters[k].fromWireType(getter(getterContext, pointer));
          }
          rawDestructor(pointer);
          return record;
        },
        argPackAdvance: GenericWireTypeSize,
        readValueFromPointer: readPointer,
        destructorFunction: rawDestructor,
      },
    ]);
  },
};
if (isEmbind) addToLibrary({ ...unused, ...records });
