// React: the diagram belongs to an effect, which makes it and disposes of it. StrictMode runs every
// effect twice; so does a change of the bubbles: each diagram is disposed of once, and never while
// something may still ask it.
import { Diagram } from "apollonius-diagram";
import { useEffect, useRef, useState } from "react";

export default function BubbleChart({ bubbles, width = 960, height = 500 }) {
  const diagram = useRef(null);
  const [picked, setPicked] = useState(-1);

  useEffect(() => {
    diagram.current = Diagram.from(bubbles);
    return () => {
      diagram.current.dispose();
      diagram.current = null;
    };
  }, [bubbles]);

  const pick = ({ nativeEvent }) =>
    setPicked(diagram.current?.pick(nativeEvent.offsetX, nativeEvent.offsetY, 20) ?? -1);

  return (
    <svg width={width} height={height} onPointerMove={pick} onPointerLeave={() => setPicked(-1)}>
      {bubbles.map(({ x, y, r }, id) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: ids of the diagram are the rows, too
        <circle key={id} cx={x} cy={y} r={r} fill={id === picked ? "#e15759" : "#4e79a7"} />
      ))}
    </svg>
  );
}
