// Sliders, choices, switches and buttons of a figure, as the platform has them.
import { make } from "../shared/dom.js";
import type { Control } from "./figure.js";

type Made = { element: HTMLElement; update(): void };
let names = 0;

function makeControl<State>(
  control: Control<State>,
  state: () => State,
  changed: () => void,
): Made {
  switch (control.kind) {
    case "slider": {
      const { min, max, step } = control;
      const text = (value: number) => String(value);
      const input = make("input", {
        type: "range",
        min: text(min),
        max: text(max),
        step: text(step),
      });
      const value = make("output", {});
      input.addEventListener("input", () => {
        control.set(state(), Number(input.value));
        changed();
      });
      const update = () => {
        input.value = text(control.get(state()));
        value.textContent = control.show?.(state()) ?? input.value;
        input.setAttribute("aria-valuetext", value.textContent);
      };
      const label = make("span", {}, control.label);
      return { element: make("label", { className: "slider" }, label, input, value), update };
    }
    case "choice": {
      const name = `choice-${++names}`;
      const inputs = control.options.map(([value]) =>
        make("input", { type: "radio", name, value }),
      );
      const element = make("fieldset", { className: "choice" });
      element.append(make("legend", { className: "visually-hidden" }, control.label));
      control.options.forEach(([value, label], k) => {
        inputs[k].addEventListener("change", () => {
          control.set(state(), value);
          changed();
        });
        element.append(make("label", {}, inputs[k], make("span", {}, label)));
      });
      const update = () => {
        for (const input of inputs) input.checked = input.value === control.get(state());
      };
      return { element, update };
    }
    case "switch": {
      const input = make("input", { type: "checkbox" });
      input.addEventListener("change", () => {
        control.set(state(), input.checked);
        changed();
      });
      const update = () => {
        input.checked = control.get(state());
      };
      return { element: make("label", { className: "switch" }, input, control.label), update };
    }
    case "button": {
      const button = make("button", { type: "button" });
      button.addEventListener("click", async () => {
        await control.act(state());
        changed();
      });
      const update = () => {
        const { label } = control;
        button.textContent = typeof label === "string" ? label : label(state());
        button.disabled = control.isDisabled?.(state()) ?? false;
      };
      return { element: button, update };
    }
  }
}

/** @param changed is called when one of them has set something */
export function makeControls<State>(
  controls: readonly Control<State>[],
  state: () => State,
  changed: () => void,
): Made {
  const made = controls.map((control) => makeControl(control, state, changed));
  const marks = made.map(() => document.createComment("")); // where controls without a use were
  const update = () => {
    for (const [k, { element, update }] of made.entries()) {
      update();
      if (controls[k].isShown?.(state()) === false) element.replaceWith(marks[k]);
      else marks[k].replaceWith(element);
    }
  };
  return {
    element: make("div", { className: "controls" }, ...made.map(({ element }) => element)),
    update,
  };
}
