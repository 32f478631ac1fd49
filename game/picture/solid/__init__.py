"""The solid view: what stands in the slots as prisms, their order, light and shadows. The desktop and the page paint it."""
