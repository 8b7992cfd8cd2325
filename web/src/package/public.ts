// What both entries export besides createRigless.

export { DocumentError } from "../document/project";
export type { Axis, Point, Settings, Vec3 } from "../document/types";
export { EngineError, type EngineErrorCode } from "../engine/types";
export { ModelError } from "../io/named-file";
export type { Dance, Mesh, MotionText, Pose, Rigless, RetargetOptions, RetargetTask } from "./rigless";
