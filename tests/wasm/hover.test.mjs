// An editor shows of each call its surface's names, units, errors, cost and an example.
import { writeFileSync } from "node:fs";
import path from "node:path";
import ts from "typescript";
import { packed } from "./support/install_packed.mjs";

const kProgram = `
import { Diagram } from "apollonius-diagram";
import { SphericalDiagram } from "apollonius-diagram/sphere";
new Diagram().find(0, 0);
new SphericalDiagram().find(0, 0);
new Diagram().voronoi([0, 0, 1, 1]).cellCircle(0);
new SphericalDiagram().voronoi().cellArea(0);
Diagram.fromBytesAsync(new Uint8Array());
`;
const file = path.join(packed, "hover.mts");

/** The quick info of a TypeScript server at each of these texts. */
function quickInfoAt(...texts) {
  writeFileSync(file, kProgram);
  const options = {
    strict: true,
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext,
    lib: ["lib.es2023.d.ts", "lib.esnext.disposable.d.ts", "lib.dom.d.ts"],
    types: [],
  };
  const service = ts.createLanguageService({
    getScriptFileNames: () => [file],
    getScriptVersion: () => "1",
    getScriptSnapshot: (name) =>
      ts.sys.fileExists(name) ? ts.ScriptSnapshot.fromString(ts.sys.readFile(name)) : undefined,
    getCurrentDirectory: () => packed,
    getCompilationSettings: () => options,
    getDefaultLibFileName: ts.getDefaultLibFilePath,
    fileExists: ts.sys.fileExists,
    readFile: ts.sys.readFile,
    directoryExists: ts.sys.directoryExists,
    getDirectories: ts.sys.getDirectories,
  });
  return texts.map((text) => {
    const info = service.getQuickInfoAtPosition(file, kProgram.indexOf(text) + text.length - 1);
    return {
      signature: ts.displayPartsToString(info.displayParts),
      text: ts.displayPartsToString(info.documentation),
      example: (info.tags ?? [])
        .filter(({ name }) => name === "example")
        .map((tag) => ts.displayPartsToString(tag.text))
        .join(),
    };
  });
}

test("hover text has the surface's names, what, errors, cost and an example", () => {
  const [find, , circle, area, bytes] = quickInfoAt(
    "new Diagram().find",
    "new SphericalDiagram().find",
    "cellCircle",
    "cellArea",
    "fromBytesAsync",
  );
  expect(find.signature).toContain(
    "find(x: number, y: number, options?: FindOptions | undefined): number",
  );
  expect(find.text).toMatch(/nearest to a point.*Cost: one location.*Throws "not-finite"/s);
  expect(find.example).toMatch(/^const id = diagram\.find\(52, 30\); \/\/ 0/);
  expect(circle.text).toMatch(/largest circle inside a cell.*Cost: .*Throws "not-finite"/s);
  expect(circle.example).toContain("cellCircle");
  expect(area.text).toMatch(/in the square of the radius' unit.*O\(d\)/s);
  expect(area.example).toContain("cellArea");
  expect(bytes.example).toContain("await Diagram.fromBytesAsync(");
});

test("on the sphere, the same call has longitude and latitude", () => {
  const [, find] = quickInfoAt("new Diagram().find", "new SphericalDiagram().find");
  expect(find.signature).toContain(
    "find(lon: number, lat: number, options?: FindOptions | undefined)",
  );
});
