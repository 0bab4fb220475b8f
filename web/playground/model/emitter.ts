// Events with types: what happens, by name, and what there is to tell about it.

/** `Details`: by the event's name, what its listeners get. */
export class Emitter<Details> extends EventTarget {
  on<Type extends keyof Details & string>(
    type: Type,
    listener: (detail: Details[Type]) => void,
    options?: AddEventListenerOptions,
  ) {
    // Only `emit` makes events of these names.
    const heard = (event: Event) => listener((event as CustomEvent<Details[Type]>).detail);
    this.addEventListener(type, heard, options);
  }

  protected emit<Type extends keyof Details & string>(type: Type, detail: Details[Type]) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
