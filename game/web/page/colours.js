// Colours of lists of primitives, which are one number each, as a canvas has them.

const styles = new Map();

export function colour(packed) {
  let style = styles.get(packed);
  if (style === undefined) {
    style = "#" + packed.toString(16).padStart(6, "0");
    styles.set(packed, style);
  }
  return style;
}
