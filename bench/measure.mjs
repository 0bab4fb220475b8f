// Runs scenes and gathers one record per operation and contender.
import { ask, stop } from "./contenders.mjs";
import { ensureSet } from "./prepare.mjs";

const kTimeout = 240; // seconds for one request that does not end by itself

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** A contender that moves sites starts from the same diagram each time. */
async function rebuild(name, set) {
  await ask(name, { op: "build", set, seconds: 0 }, kTimeout);
}

async function askStep(name, step, set) {
  const { op, who, rounds, fresh, rebuild: isToBeRebuilt, ...options } = step;
  if (fresh) stop(name);
  if (isToBeRebuilt) await rebuild(name, set);
  return ask(name, { op, set, ...options }, Math.max(kTimeout, 2 * (step.limit ?? 0)));
}

/** Adds an answer to the record of earlier rounds. */
function merge(record, { samples = [], ...facts }) {
  Object.assign(record, facts);
  record.samples.push(...samples);
}

function summary({ samples, ...record }) {
  if (samples.length === 0) return record;
  return {
    ...record,
    us: median(samples),
    fastest: Math.min(...samples),
    slowest: Math.max(...samples),
    samples: samples.length,
  };
}

/** Runs one scene; its records. `isThere` tells which contenders take part. */
async function runScene(scene, isThere, progress) {
  const set = ensureSet(scene.family, scene.n);
  const records = new Map();
  for (let round = 0; round < scene.rounds; ++round) {
    for (const [index, step] of scene.steps.entries()) {
      if (round >= (step.rounds ?? scene.rounds)) continue;
      const who = step.who.filter(isThere);
      for (let k = 0; k < who.length; ++k) {
        const contender = who[(k + round) % who.length]; // each is first in turn
        const key = `${index} ${contender}`;
        const record = records.get(key) ?? {
          part: scene.part,
          family: scene.family,
          n: scene.n,
          ...(scene.label && { label: scene.label }),
          op: step.op,
          contender,
          samples: [],
        };
        records.set(key, record);
        if (record.error) continue; // once too slow, always too slow
        progress(
          `${scene.part}: ${scene.family} ${scene.n}, ${step.op}, ${contender}, ` +
            `round ${round + 1} of ${scene.rounds}`,
        );
        merge(record, await askStep(contender, step, set));
      }
    }
  }
  return [...records.values()].map(summary);
}

export async function runScenes(scenes, isThere, progress) {
  const records = [];
  for (const [k, scene] of scenes.entries()) {
    records.push(...(await runScene(scene, isThere, (text) => progress(k / scenes.length, text))));
  }
  return records;
}

/**
 * The disagreements of contenders that should agree: on the number of visible sites, and on the
 * results of queries (wasm and native).
 */
export function disagreements(records) {
  const groups = new Map();
  for (const record of records) {
    // these did different amounts of work
    if (record.isCutOff || record.error || record.part === "moves") continue;
    const key = [record.part, record.family, record.n, record.op].join(" ");
    groups.set(key, [...(groups.get(key) ?? []), record]);
  }
  return [...groups].flatMap(([key, group]) => {
    const visible = new Set(
      group.map((record) => record.visible || 0).filter((count) => count > 0),
    );
    const sinks = new Set(
      group
        .filter(({ contender }) => contender === "wasm" || contender === "native")
        .map(({ sink }) => sink || 0),
    );
    return [
      ...(visible.size > 1 ? [`${key}: visible sites ${[...visible].join(", ")}`] : []),
      ...(sinks.size > 1 ? [`${key}: results ${[...sinks].join(", ")}`] : []),
    ];
  });
}
