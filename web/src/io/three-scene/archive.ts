import { DocumentError } from "../../document/project";
import { ModelError, type NamedFile } from "../named-file";
import { unzip } from "../zip";

/** What an archive that is a model holds, unpacked by nobody yet. Errors (ModelError): as unzip. */
export function checkedArchive(file: NamedFile): string[] {
  const paths: string[] = [];
  try {
    unzip(file, (path) => {
      paths.push(path);
      return false;
    });
  } catch (error) {
    throw error instanceof DocumentError ? new ModelError(error.message) : error;
  }
  return paths;
}
