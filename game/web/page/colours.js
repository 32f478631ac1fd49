// Converts a colour from one number, as lists of primitives have it, to CSS, as a canvas needs it.

const styles = new Map();

export function colour(packed) {
  let style = styles.get(packed);
  if (style === undefined) {
    style = "#" + packed.toString(16).padStart(6, "0");
    styles.set(packed, style);
  }
  return style;
}
