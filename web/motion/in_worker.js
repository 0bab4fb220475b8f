// Something long in a worker of its own, which can be stopped.

/**
 * @param {string} script gets the request; posts what there is to tell, and in the end { result }
 *   or { failure }
 * @param {object} request
 * @param {(told: any) => void} tell
 * @param {AbortSignal} [signal]
 * @returns {Promise<any>} the result
 */
export async function inWorker(script, request, tell, signal) {
  const worker = new Worker(script, { type: "module" });
  try {
    return await new Promise((resolve, reject) => {
      signal?.addEventListener("abort", () => reject(signal.reason));
      worker.onerror = (event) => reject(new Error(event.message || "the worker failed"));
      worker.onmessage = ({ data }) => {
        if (data.failure) reject(Object.assign(new Error(data.failure), { code: data.code }));
        else if (data.result) resolve(data.result);
        else tell(data);
      };
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}
