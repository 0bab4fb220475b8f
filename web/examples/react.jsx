// React: the diagram is a value that follows from the bubbles, so useMemo makes it. No effect, no
// clean-up: a diagram that nobody uses any more is collected. StrictMode, which renders twice, and
// renderToString on a server need nothing else; server and browser compute the same bits, so the
// paths are the same strings and hydration finds nothing to mend.
import { Diagram } from "apollonius-diagram";
import { useMemo, useState } from "react";

/** Bubbles are {x, y, r}, in a new array whenever one changes; picks within 20 pixels. */
export default function BubbleChart({ bubbles, width = 960, height = 500 }) {
  const diagram = useMemo(() => Diagram.from(bubbles), [bubbles]);
  const borders = useMemo(
    () => diagram.voronoi([0, 0, width, height]).render(null, { digits: 1 }),
    [diagram, width, height],
  );
  // Kept is where the pointer is: who is there follows from that, and from the bubbles of now.
  const [pointer, setPointer] = useState(null);
  const picked = pointer ? diagram.pick(...pointer, { maxDistance: 20 }) : -1;

  return (
    <svg
      width={width}
      height={height}
      onPointerMove={({ nativeEvent: { offsetX, offsetY } }) => setPointer([offsetX, offsetY])}
      onPointerLeave={() => setPointer(null)}
    >
      {bubbles.map(({ x, y, r }, id) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: ids of the diagram are the rows, too
        <circle key={id} cx={x} cy={y} r={r} fill={id === picked ? "#e15759" : "#4e79a7"} />
      ))}
      <path d={borders} fill="none" stroke="#bbb" />
    </svg>
  );
}
