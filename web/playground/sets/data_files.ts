// The files of web/data that the page fetches.
const asked = new Map<string, Promise<unknown>>();

/** The content of our own file. It is asked for once; again if that failed. */
export function fetchData<Data>(name: string): Promise<Data> {
  let file = asked.get(name);
  if (!file) {
    file = fetchJson(name);
    file.catch(() => asked.delete(name));
    asked.set(name, file);
  }
  return file as Promise<Data>;
}

async function fetchJson(name: string): Promise<unknown> {
  const response = await fetch(`../data/${name}`);
  if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
  return response.json();
}
