/** What is told of a model that its file poses by a skeleton. */
export const SKINNED = "This file already has a skeleton. We use its current pose and the names of its joints, and leave the bones out.";
