"use strict";

document.addEventListener("DOMContentLoaded", () => {
  const { scenes } = JSON.parse(document.getElementById("page-data").textContent);
  for (const root of document.querySelectorAll("[data-scene]"))
    new ScenePanel(root, scenes[Number(root.dataset.scene)]);
});
