declare module "virtual:opened-messages" {
  /** Fluent source of the sentences of the package's page. */
  const text: string;
  export default text;
}
