/** Windrow: wind around a player on a voxel grid. Lengths are metres, speeds metres a second, y is up. */
export type Vector = [number, number, number];
/** Handle of a motor or an obstacle; opaque. */
export interface Id { slot: number; generation: number; owner: number }
/** Fields of windrow_config (docs/scene_keys.md has units and ranges); what is left out keeps its default. */
export interface Config {
    cells?: Vector; cell_size?: number; centre?: Vector; floor?: number; ambient?: Vector; viscosity?: number; relaxation_time?: number;
    scheme?: "second_order" | "stable_fluids"; interpolation?: "linear" | "cubic" | "cubic_32"; max_cfl?: number; max_substeps?: number; ticks_hz?: number;
    boundaries?: Partial<Record<"x_low" | "x_high" | "y_low" | "y_high" | "z_low" | "z_high", {kind: "open" | "free_slip" | "no_slip" | "periodic"; wall_velocity?: Vector}>>;
    gusts?: {intensity?: number; length?: number; seed?: number};
    profile?: {roughness_length?: number; reference_height?: number};
    canopy?: {height?: number; drag?: number};
    roughness?: {length?: number; longest_mixing?: number};
    rows?: {first?: number; uniform?: number; ratio?: number; top?: number};
    [field: string]: unknown;
}
export type MotorKind = "directional" | "wake" | "jet" | "vortex" | "omni" | "pressure";
/** Fields of windrow_directional_motor and so on; of a drive {kind: "drive", speed, rate}. */
export interface Motor { position?: Vector; direction?: Vector; radius?: number; speed?: number; law?: Record<string, unknown>; [field: string]: unknown }
export interface Box { cells: Vector; cell_size: number; size: Vector; origin: Vector }
export interface Advance { ticks: number; dropped: number; factor: number }

/** The C interface, for what Wind does not have: c_api/*.h. A call that the library rejects throws its sentence. */
export class Library {
    readonly version: string;
    call(name: string, ...values: unknown[]): number;
    make(struct: string, values?: object): number;
    read(struct: string, at: number): Record<string, unknown>;
    within<Result>(body: () => Result): Result;
    handle(name: string, ...values: unknown[]): number;
    bytes(name: string, ...values: unknown[]): Uint8Array;
}
export class Wind {
    /** `outer`: a larger wind of the same library around the box, whose mean wind, profile and gusts it takes; advance it first in each frame. */
    constructor(library: Library, config?: Config, around?: {outer?: Wind | null});
    destroy(): void;
    advance(dt: number): Advance;
    step(dt: number): Record<string, unknown>;
    follow(point: Vector): void;
    velocity(point: Vector): Vector;
    box(): Box;
    add(kind: MotorKind, motor: Motor): Id;
    set(kind: MotorKind, id: Id, motor: Motor): void;
    move(id: Id, position: Vector): void;
    remove(id: Id): void;
    /** x, y, z, 0 a cell as halves, x fastest: a 3D texture. Good until the next call. */
    halves(): Uint16Array;
    /** The uniform buffer of windrow_wind.glsl: 1072 bytes. */
    frameBlock(anchor?: Vector, sampling?: object): Uint8Array;
    gustTile(): Float32Array | null;
}
/** The library, with vector instructions where this machine has them (`simd` decides otherwise). */
export function load(options?: {simd?: boolean}): Promise<Library>;
export function hasSimd(): boolean;
/** windrow_wind.glsl for GLSL ES 3.00, with all that it includes; write it behind your `precision` statements. */
export const windrow_wind_glsl: string;
