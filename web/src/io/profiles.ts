// The kinds of file that a dance is exported as: one row each. A new one is a file in profiles/ and a row here.

import type { Profile } from "./profile";
import { cartoonMorphs } from "./profiles/cartoon-morphs";
import { gameCharacter } from "./profiles/game-character";
import { morphTargets } from "./profiles/morph-targets";

/** The usual one first. */
export const PROFILES: readonly [Profile, ...Profile[]] = [gameCharacter, cartoonMorphs, morphTargets];
