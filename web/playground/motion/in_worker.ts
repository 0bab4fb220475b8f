// Something long in a worker of its own, which can be stopped.

/** What a worker posts: what there is to tell, and in the end what has come of it. */
export type Told<Result, Progress> =
  | { kind: "progress"; progress: Progress }
  | { kind: "result"; result: Result }
  | { kind: "failure"; message: string; code?: string };

/** What went wrong in a worker, with the package's code if it has one. */
export class WorkerError extends Error {
  constructor(
    message: string,
    readonly code: string | undefined,
  ) {
    super(message);
  }
}

/**
 * @param start of a worker that gets the request, and posts what is `Told`; resolves to the result
 */
export async function inWorker<Result, Progress>(
  start: () => Worker,
  request: unknown,
  tell: (progress: Progress) => void,
  signal?: AbortSignal,
): Promise<Result> {
  const worker = start();
  try {
    return await new Promise((resolve, reject) => {
      signal?.addEventListener("abort", () => reject(signal.reason));
      worker.onerror = (event) => reject(new Error(event.message || "the worker failed"));
      worker.onmessage = ({ data: told }: MessageEvent<Told<Result, Progress>>) => {
        if (told.kind === "failure") reject(new WorkerError(told.message, told.code));
        else if (told.kind === "result") resolve(told.result);
        else tell(told.progress);
      };
      worker.postMessage(request);
    });
  } finally {
    worker.terminate();
  }
}
