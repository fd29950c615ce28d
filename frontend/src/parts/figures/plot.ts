/** The parts of Observable Plot that the figures use; imported on demand, so that nothing else waits for them. */
export { areaX, areaY, dot, line, plot, ruleX, ruleY, text } from "@observablehq/plot";
