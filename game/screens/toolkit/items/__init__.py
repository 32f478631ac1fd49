"""The items of forms: text, buttons, switches, lists, sliders, fields."""
