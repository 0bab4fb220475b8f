// CommonJS: `require` gives the same names, and nothing is to be awaited.
const { Diagram } = require("apollonius-diagram");

const diagram = new Diagram([100, 80, 50, 190, 90, 15, 105, 90, 10]);
console.log(diagram.find(155, 88), diagram.hiddenSize);
