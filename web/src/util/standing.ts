// Where somebody stands who dances beside the model.

/** From a companion's own world to that of the model: turned about the vertical by radians, then moved over the floor. */
export interface Standing {
  readonly x: number;
  readonly z: number;
  readonly yaw: number;
}
