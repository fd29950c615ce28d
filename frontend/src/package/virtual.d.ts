declare module "virtual:opened-messages" {
  /** Fluent source of the sentences of the package's page, by language. */
  const catalogues: Readonly<Record<string, string>>;
  export default catalogues;
}
