// What hands make, for the worker and the page: the bodies of things, and motors in the words of the C interface.

export const UNITS_A_SECOND = 240; // of time, in the log
export const FAN_HEIGHT = 1.3;

// A panel changes the values.
export const MAKES = {
    fan: {kind: "jet", values: {length: 8, start_radius: 0.8, end_radius: 1.8, law: {kind: "drive", speed: 13, rate: 8}}},
    blast: {kind: "pressure", values: {radius: 2.2, speed: 22, duration: 0.35}},
    stroke: {kind: "wake", values: {radius: 0.75, law: {kind: "drive", per_metre: 6, entrainment: 1}}},
    walker: {kind: "wake", values: {radius: 0.4, law: {kind: "drive", per_metre: 6, entrainment: 1}}},
};

/** Bodies of an object of a kind, from its place [m] and yaw [deg]: position, turn_deg, shape. */
export function bodiesOf(kind, at, yaw) {
    const [x, y, z] = at;
    if (kind === "stone") return [{position: [x, y + 0.35, z], turn_deg: [yaw, 0, 0], shape: {sphere: {radius: 0.9}}}];
    if (kind === "house")
        return [
            {position: [x, y + 1.3, z], turn_deg: [yaw, 0, 0], shape: {block: {half_size: [2.4, 1.3, 1.7]}}},
            {position: [x, y + 2.6, z], turn_deg: [yaw, 45, 0], shape: {block: {half_size: [2.39, 1.2, 1.2]}}},
        ];
    return [];
}
export const fanDirection = (yaw) => [Math.cos((yaw * Math.PI) / 180), 0, -Math.sin((yaw * Math.PI) / 180)];
