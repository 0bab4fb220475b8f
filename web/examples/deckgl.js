// deck.gl: what the pointer is near, by the diagram in place of deck.gl's picking. That draws the
// layer once more and looks at the pixels around the pointer, of which the closest one counts; the
// diagram knows the circles, those too that others cover on the screen: the smallest one under the
// pointer, or else the nearest within reach, exactly, without the GPU.
import { Deck, OrthographicView } from "@deck.gl/core";
import { ScatterplotLayer } from "@deck.gl/layers";
import { Diagram } from "apollonius-diagram";

const reach = 20; // pixels

/** Bubbles are {x, y, r}; `onPick` gets the id of one, or -1. */
export default function nearestInDeck(container, bubbles, onPick = (_id) => {}) {
  const diagram = Diagram.from(bubbles);
  container.style.position = "relative"; // deck.gl's canvas is as large as what is positioned
  let picked = -1;

  const layers = () => [
    new ScatterplotLayer({
      id: "bubbles",
      data: bubbles,
      getPosition: ({ x, y }) => [x, y],
      getRadius: ({ r }) => r,
      getFillColor: (_, { index }) => (index === picked ? [225, 87, 89] : [78, 121, 167]),
      updateTriggers: { getFillColor: picked },
      opacity: 0.8,
    }),
  ];
  const { clientWidth, clientHeight } = container;
  const deck = new Deck({
    parent: container,
    views: new OrthographicView(),
    initialViewState: { target: [clientWidth / 2, clientHeight / 2, 0], zoom: 0 },
    controller: true,
    layers: layers(),
  });

  const pick = (id) => {
    if (id === picked) return;
    picked = id;
    deck.setProps({ layers: layers() });
    onPick(id);
  };
  const at = ({ clientX, clientY }) => {
    const [viewport] = deck.getViewports();
    if (!viewport) return -1; // before the first frame
    const { left, top } = container.getBoundingClientRect();
    const [x, y] = viewport.unproject([clientX - left, clientY - top]);
    return diagram.pick(x, y, { maxDistance: reach / viewport.scale });
  };
  container.addEventListener("pointermove", (event) => pick(at(event)));
  container.addEventListener("pointerleave", () => pick(-1));

  /** To be called when the chart goes; then its container is empty again. */
  const end = () => {
    deck.finalize();
    diagram.dispose();
  };
  return { deck, diagram, picked: () => picked, end };
}
