/** The prototypes that a class of the package and those it extends give to objects. */
export function prototypesOf(type) {
  const found = [];
  const foreign = [Object.prototype, Error.prototype];
  for (let at = type.prototype; !foreign.includes(at); at = Object.getPrototypeOf(at))
    found.push(at);
  return found;
}

/** The names and symbols of what objects of a class have from these. */
export function methodsOf(type) {
  return [...new Set(prototypesOf(type).flatMap(Reflect.ownKeys))];
}
