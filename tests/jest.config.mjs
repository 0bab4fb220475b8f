// Jest's projects; tests/run.mjs selects among them. Tests are ES modules and are not transformed.
import { fileURLToPath } from "node:url";

const rootDir = fileURLToPath(new URL("..", import.meta.url));
const common = { rootDir, roots: ["<rootDir>/tests"], testEnvironment: "node", transform: {} };
const buildSite = "<rootDir>/tests/web/support/build.mjs";

export default {
  rootDir,
  testTimeout: 900_000, // ms; it ends what hangs: no time decides whether a test passes
  projects: [
    { ...common, displayName: "package", testMatch: ["<rootDir>/tests/wasm/**/*.test.mjs"] },
    { ...common, displayName: "layers", testMatch: ["<rootDir>/tests/*.test.mjs"] },
    { ...common, displayName: "cluster", testMatch: ["<rootDir>/tests/cluster/**/*.test.mjs"] },
    { ...common, displayName: "debug", testMatch: ["<rootDir>/tests/debug/*.test.mjs"] },
    {
      ...common,
      displayName: "strangers",
      testMatch: ["<rootDir>/tests/strangers/*.test.mjs"],
      globalSetup: buildSite,
    },
    {
      ...common,
      displayName: "web",
      testMatch: ["<rootDir>/tests/web/**/*.test.mjs"],
      globalSetup: buildSite,
    },
  ],
};
