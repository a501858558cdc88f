// The panel: a row a setting from the library's tables. What the library rejects is red, with its sentence.
const GROUPS = {air: "Air of the scene", profile: "Profile", gusts: "Gusts", fan: "Fans", blast: "Blasts", stroke: "Strokes"};
const VECTORS = ["vec3", "ivec3", "dvec3"];
const LAW_ROWS = [{name: "law.speed", unit: "m/s", meaning: "Speed that it drives the air to."}, {name: "law.rate", unit: "1/s", meaning: "How fast."}];

export class Panel {
    /** `change(group, name, value)` returns a promise of null or of the sentence of what is wrong. */
    constructor(element, tables, change) {
        Object.assign(this, {element, tables, change});
        this.inputs = {};
        for (const [group, title] of Object.entries(GROUPS)) {
            const details = document.createElement("details");
            details.open = group === "gusts";
            details.innerHTML = `<summary>${title}</summary>`;
            const rows = [...tables[group].filter((row) => !/Law$/.test(row.type)), ...(group === "fan" ? LAW_ROWS : [])];
            for (const row of rows) details.append(this.row(group, row));
            element.append(details);
        }
    }
    row(group, row) {
        const label = document.createElement("label");
        const input = document.createElement("input");
        const words = [row.meaning, row.range && `Range: ${row.range}.`].filter(Boolean).join(" ");
        Object.assign(input, {type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false, name: `${group}.${row.name}`, title: words});
        const name = document.createElement("span");
        name.textContent = row.name.replace(/^law\./, "").replace(/_/g, " ") + (row.unit ? ` [${row.unit}]` : "");
        const says = document.createElement("output");
        label.append(name, input, says);
        label.title = words;
        input.addEventListener("change", async () => {
            const value = this.read(row, input.value);
            const fault = value === undefined ? `'${input.value}' is no ${VECTORS.includes(row.type) ? "list of numbers" : "number"}` : await this.change(group, row.name, value);
            label.classList.toggle("wrong", fault !== null);
            input.setAttribute("aria-invalid", String(fault !== null));
            says.textContent = fault ?? "";
        });
        this.inputs[input.name] = {input, row, label, says};
        return label;
    }
    read(row, text) {
        if (VECTORS.includes(row.type)) {
            const values = text.split(/[\s,]+/).filter(Boolean).map(Number);
            return values.length === 3 && values.every(Number.isFinite) ? values : undefined;
        }
        if (["Scheme", "Interpolation"].includes(row.type)) return text;
        const value = Number(text);
        return text.trim() !== "" && Number.isFinite(value) ? value : undefined;
    }
    /** Fills the rows from groups of values; what a group lacks has its default. */
    show(values) {
        for (const [key, {input, row, label, says}] of Object.entries(this.inputs)) {
            const [group, ...path] = key.split(".");
            const value = path.reduce((inner, word) => inner?.[word], values[group]) ?? row.default ?? "";
            input.value = Array.isArray(value) ? value.join(", ") : String(value);
            label.classList.remove("wrong");
            input.setAttribute("aria-invalid", "false");
            says.textContent = "";
        }
    }
}
