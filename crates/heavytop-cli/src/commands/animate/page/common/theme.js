// Light or dark: as the system has it, or as somebody chose.

const theme = {
  system: matchMedia("(prefers-color-scheme: dark)"),
  chosen: undefined,
  listeners: [],

  get isDark() {
    return this.chosen === undefined ? this.system.matches : this.chosen === "dark";
  },

  /** Chooses "light" or "dark"; undefined follows the system. */
  choose(name) {
    this.chosen = name;
    this.apply();
  },

  /** Calls back after each change, when the colours are those of the theme. */
  onChange(listener) {
    this.listeners.push(listener);
  },

  apply() {
    document.documentElement.dataset.theme = this.isDark ? "dark" : "light";
    for (const listener of this.listeners) listener();
  },
};

theme.apply();
theme.system.addEventListener("change", () => theme.apply());
