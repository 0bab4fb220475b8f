// All tools, in the order of their buttons.
import { deleteTool } from "./delete_tool.js";
import { drawTool } from "./draw_tool.js";
import { panTool } from "./pan_tool.js";
import { selectTool } from "./select_tool.js";
import type { Tool } from "./tool.js";

export const kTools: readonly Tool[] = [selectTool, drawTool, panTool, deleteTool];

const byId = new Map(kTools.map((tool) => [tool.id, tool]));
const byKey = new Map(kTools.map((tool) => [tool.key, tool.id]));

export const toolOf = (id: string): Tool => byId.get(id) ?? selectTool;

/** The tool that a key chooses. */
export const toolOfKey = (key: string) => byKey.get(key);
