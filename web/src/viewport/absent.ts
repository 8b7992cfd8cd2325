// Takes the place of parts of three.js that GLTFLoader names and a look never has: skins, clips, lights, lines, points and what
// fetches. They would come with the first load (vite.config.ts).

class Absent {}

export {
  Absent as AnimationClip,
  Absent as Bone,
  Absent as InstancedMesh,
  Absent as Interpolant,
  Absent as Line,
  Absent as LineBasicMaterial,
};
export { Absent as LineLoop, Absent as LineSegments, Absent as NumberKeyframeTrack, Absent as PointLight, Absent as Points };
export { Absent as PointsMaterial, Absent as QuaternionKeyframeTrack, Absent as Skeleton, Absent as SkinnedMesh, Absent as SpotLight };
export { Absent as VectorKeyframeTrack };

/** Made for every document, asked for nothing. */
class Idle {
  setCache(): void {}
  setCrossOrigin(): void {}
  setPriority(): void {}
  setRequestHeader(): void {}
  setResponseType(): void {}
  setWithCredentials(): void {}
}

export { Idle as FileLoader, Idle as ImageBitmapLoader, Idle as TextureLoader };

export const PropertyBinding = { sanitizeNodeName: (name: string): string => name };
