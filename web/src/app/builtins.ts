import characterList from "../../assets/characters/index.json";
import motionList from "../../assets/motions/index.json";
import { parseProject } from "../document/project";
import type { ProjectDocument } from "../document/types";
import { baseName, normalPath } from "../io/named-file";

/** A model that comes with the page, with points and poses of its own. */
export interface Character {
  readonly id: string;
  readonly name: string;
  /** Its project, seen from the folder of the list. */
  readonly project: string;
  readonly vertices: number;
  readonly credit: string;
}

/** A motion that comes with the page. */
export interface Dance {
  readonly file: string;
  readonly name: string;
  readonly seconds: number;
}

const CHARACTERS = "characters/";
const MOTIONS = "motions/";

/** Where the build put each asset, by its path under `assets`. */
const ADDRESSES = new Map(
  Object.entries(
    import.meta.glob<string>(["../../assets/**/project.json", "../../assets/**/*.{glb,bvh,webp}"], {
      query: "?url",
      import: "default",
      eager: true,
    }),
  ).map(([path, url]) => [path.replace(/^.*?\/assets\//, ""), url]),
);

/** What comes with the page. In documents its files are named without folders. */
export class Builtins {
  readonly characters: readonly [Character, ...Character[]] = characterList as [Character, ...Character[]];
  readonly motions: readonly Dance[] = motionList;

  /** Documents call the character's model so. */
  modelFile(character: Character): string {
    return baseName(modelPath(character));
  }

  /** The project as it was made, and the model's bytes. */
  async load(character: Character): Promise<{ document: ProjectDocument; bytes: Uint8Array }> {
    const [project, model] = await Promise.all([fetched(projectPath(character)), fetched(modelPath(character))]);
    const { document } = parseProject(await project.text(), "project.json");
    return {
      document: {
        ...document,
        mesh: { ...document.mesh, file: this.modelFile(character) },
        motion: { files: document.motion.files.map(baseName) },
      },
      bytes: new Uint8Array(await model.arrayBuffer()),
    };
  }

  async motionText(file: string): Promise<string> {
    return (await fetched(MOTIONS + file)).text();
  }

  /** The address of a small strip of pictures, or null if it was not drawn yet. */
  picture(of: Character | Dance): string | null {
    return (
      ADDRESSES.get("id" in of ? `${CHARACTERS}pictures/${of.id}.webp` : `${MOTIONS}pictures/${of.file.replace(/\.bvh$/, ".webp")}`) ?? null
    );
  }
}

function projectPath({ project }: Character): string {
  return normalPath(CHARACTERS + project);
}

/** The model that lies beside the project. */
function modelPath(character: Character): string {
  const folder = projectPath(character).replace(/[^/]*$/, "");
  return [...ADDRESSES.keys()].find((path) => path.startsWith(folder) && /^[^/]*\.glb$/.test(path.slice(folder.length))) ?? "";
}

async function fetched(path: string): Promise<Response> {
  const response = await fetch(ADDRESSES.get(path) ?? path);
  if (!response.ok) throw new Error(`${baseName(path)} could not be loaded (${response.status}).`);
  return response;
}
