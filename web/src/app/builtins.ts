import { DEFAULT_SETTINGS } from "../document/commands";
import type { ProjectDocument } from "../document/types";
import { baseName, normalPath } from "../io/named-file";
import type { AssetsPort, Character, Dance } from "./ports";

const CHARACTERS = "characters/";
const MOTIONS = "motions/";

/** What comes with the page. In documents its files are named without folders. */
export class Builtins {
  constructor(private readonly assets: AssetsPort) {}

  get characters(): readonly [Character, ...Character[]] {
    return this.assets.characters;
  }
  get motions(): readonly Dance[] {
    return this.assets.motions;
  }

  /** Documents call the character's model so. */
  modelFile(character: Character): string {
    return baseName(this.modelPath(character));
  }

  /** The project as it was made, and the model's bytes. */
  async load(character: Character): Promise<{ document: ProjectDocument; bytes: Uint8Array }> {
    const { assets } = this;
    const [project, bytes] = await Promise.all([assets.load(projectPath(character)), assets.load(this.modelPath(character))]);
    const document: ProjectDocument = JSON.parse(new TextDecoder().decode(project)); // ours: a test reads it as any other is read
    return {
      document: {
        ...document,
        settings: { ...DEFAULT_SETTINGS, ...document.settings },
        mesh: { ...document.mesh, file: this.modelFile(character) },
        motion: { files: document.motion.files.map(baseName) },
      },
      bytes,
    };
  }

  async motionText(file: string): Promise<string> {
    return new TextDecoder().decode(await this.assets.load(MOTIONS + file));
  }

  /** The address of a small strip of pictures, or null if it was not drawn yet. */
  picture(of: Character | Dance): string | null {
    const path = "id" in of ? `${CHARACTERS}pictures/${of.id}.webp` : `${MOTIONS}pictures/${of.file.replace(/\.bvh$/, ".webp")}`;
    return this.assets.address(path);
  }

  /** The model that lies beside the project. */
  private modelPath(character: Character): string {
    const folder = projectPath(character).replace(/[^/]*$/, "");
    return this.assets.paths.find((path) => path.startsWith(folder) && /^[^/]*\.glb$/.test(path.slice(folder.length))) ?? "";
  }
}

function projectPath({ project }: Character): string {
  return normalPath(CHARACTERS + project);
}
