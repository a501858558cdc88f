// Two small drawings on a canvas: time of ticks and frames, and errors against time.
export class Graph {
    constructor(canvas) {
        this.canvas = canvas;
        this.rows = [];
    }
    add(frame, tick) {
        this.rows.push([frame, tick]);
        if (this.rows.length > 120) this.rows.shift();
    }
    draw() {
        const {canvas} = this;
        const pen = canvas.getContext("2d");
        const [w, h] = [canvas.width, canvas.height];
        pen.clearRect(0, 0, w, h);
        const y = (ms) => h - 2 - (Math.min(ms, 50) / 50) * (h - 4);
        pen.fillStyle = "#ffffff40";
        pen.fillRect(0, y(1000 / 60), w, 1);
        for (const [column, colour] of [[0, "#ffe08a"], [1, "#8fd0ff"]]) {
            pen.strokeStyle = colour;
            pen.beginPath();
            this.rows.forEach((row, n) => pen.lineTo((n * w) / 120, y(row[column])));
            pen.stroke();
        }
    }
    means() {
        const recent = this.rows.slice(-30);
        return [0, 1].map((column) => recent.reduce((sum, row) => sum + row[column], 0) / Math.max(recent.length, 1));
    }
}

/** Errors of schemes against time, on an axis of powers of ten from 1e-4 to 1. */
export function drawErrors(canvas, points) {
    const pen = canvas.getContext("2d");
    const [w, h] = [canvas.width, canvas.height];
    pen.clearRect(0, 0, w, h);
    pen.font = "11px sans-serif";
    const x = (time) => 38 + (time / Math.PI) * (w - 46), y = (error) => 6 + (-Math.log10(Math.max(error, 1e-4)) / 4) * (h - 26);
    pen.fillStyle = "#fff";
    for (let power = 0; power <= 4; ++power) {
        pen.fillText(`1e-${power}`, 4, y(10 ** -power) + 4);
        pen.fillRect(38, y(10 ** -power), w - 46, 0.5);
    }
    pen.fillText("time, to pi", w / 2 - 20, h - 4);
    ["#ff9d7a", "#8fe39b"].forEach((colour, scheme) => {
        pen.strokeStyle = pen.fillStyle = colour;
        pen.lineWidth = 2;
        pen.beginPath();
        for (const point of points.filter((one) => one.scheme === scheme)) pen.lineTo(x(point.time), y(point.error));
        pen.stroke();
    });
    pen.lineWidth = 1;
}
