/** What went wrong, in words to be shown. */
export function errorText(error: unknown): string {
  const message = error instanceof Error ? error.message : String(error);
  // Browsers say this each in their own way, with an address that nobody needs.
  if (/dynamically imported module|importing a module script|module script failed/i.test(message))
    return "A part of the page could not be fetched. Check the connection and try again; nothing is lost.";
  return message;
}
